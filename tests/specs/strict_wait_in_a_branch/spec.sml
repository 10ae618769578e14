// A strict `wait` in one branch makes the whole cut strict: what a message of another branch would end, it violates.
//
// 0: ok to 1, start to 2, stop to 0. 1 busy: start to 3. 2: ok to 4 by the second branch; stop loses; a second start breaks the
// assumption. 3 turn 3, ok to come: one to 6, where nothing is strict any more. 4 turn 3: one to 7. 6: ok to 8, stop to 0. 7
// and 8 wait for stop, to 0 and 1; ok ends them, to 1. In 6, 7, 8 start ends the copy and starts another, to 2 or 3.
specification StrictWaitInABranch {
  domain d { class Ctl { start() ok() stop() } class Dev { busy: bool  one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects { User -> Ctl.ok() { dev.busy = true }  Ctl -> Dev.one() { receiver.busy = false } }
  controllable { Ctl }
  collaboration C {
    guarantee scenario Both {
      user -> ctl.start()
      parallel { wait strict [dev.busy]  urgent ctl -> dev.one() } and { user -> ctl.ok() }
      user -> ctl.stop()
    }
    assumption scenario OnlyOnce {
      user -> ctl.start()
      ctl -> dev.one()
    } constraints [ forbidden user -> ctl.start() ]
  }
}
