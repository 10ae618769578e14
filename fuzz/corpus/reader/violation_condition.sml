// `violation [c]` forbids a message in some states of the world.
//
// 0 cold: start to 1, heated to 2, cooled to 0. 1 `go` is open, turn 5: go to 0, yield to 3. 2 hot: start to 4, cooled to 0. 3 is
// 1 yielded: start to 1, heated to 4, cooled to 1. 4 hot, `go` is open but would violate `NotWhileHot`, so turn 6:
// start to 4, cooled to 1. It will be cooled, so the system wins from 4, and from all but 3, where the environment may be
// silent; with classic semantics it may not.
specification ViolationCondition {
  domain d { class Ctl { start() heated() cooled() } class Dev { hot: bool  go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects {
    Dev -> Ctl.heated() { sender.hot = true }
    Dev -> Ctl.cooled() { sender.hot = false }
  }
  controllable { Ctl }
  collaboration C {
    guarantee scenario Goes { user -> ctl.start()  eventually ctl -> dev.go() }
    guarantee scenario NotWhileHot { ctl -> dev.go()  violation [dev.hot] }
    assumption scenario CoolsDown {
      dev -> ctl.heated()
      eventually dev -> ctl.cooled()
    } constraints [ forbidden dev -> ctl.heated() ]
  }
}
