// A strict `wait` makes the cut strict.
//
// 0 not ready: start to 1, isReady to 2. 1 waits, strictly: start violates, to the lost state; isReady to 3. 2 ready: start
// passes the wait at once, to 3; a second isReady breaks the assumption. 3 turn 3: go to 0. The environment wins everywhere:
// in the end it starts twice.
specification WaitStrict {
  domain d { class Ctl { start() isReady() } class Dev { ready: bool  go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects {
    Dev -> Ctl.isReady() { sender.ready = true }
    Ctl -> Dev.go() { receiver.ready = false }
  }
  controllable { Ctl }
  collaboration C {
    guarantee scenario GoWhenReady {
      user -> ctl.start()
      wait strict [dev.ready]
      urgent ctl -> dev.go()
    }
    assumption scenario ReadyOnce {
      dev -> ctl.isReady()
      ctl -> dev.go()
    } constraints [ forbidden dev -> ctl.isReady() ]
  }
}
