// An offered case that is empty is over at once, and so is the alternative; a case that is not offered does not count.
//
// 0: start to 1. 1 turn 3: two, which makes dev busy, to 2. 2: start to 3. 3 turn 3, the empty case is not offered: one to 4. 4
// turn 3: two to 2.
specification EmptyCase {
  domain d { class Ctl { start() ok() stop() } class Dev { busy: bool  one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects { Ctl -> Dev.two() { receiver.busy = true } }
  controllable { Ctl }
  collaboration C {
    guarantee scenario Skip {
      user -> ctl.start()
      alternative { urgent ctl -> dev.one() } or [!dev.busy] { }
      urgent ctl -> dev.two()
    }
  }
}
