// An event that matches several initial messages starts one copy, behind the first of them; the other branch waits for another
// event.
//
// 0: start to 1, one copy, behind the first. 1 turn 3: one to 2. 2 waits in the second branch: start moves it, and starts
// another copy: to 3. 3 turn 3: one, which ends the first copy as another message, to 2; two, which ends the second likewise,
// to 0.
specification FirstInitialMessage {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Start {
      parallel { user -> ctl.start()  urgent ctl -> dev.one() } and { user -> ctl.start()  urgent ctl -> dev.two() }
    }
  }
}
