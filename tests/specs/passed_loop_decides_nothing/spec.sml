// A loop that is passed at the front of a case decides nothing: the message behind it and the other case stay offered.
//
// 0: start to 1, ok to 0. 1 turn 3, before one and two, as the loop is passed and decides nothing: both to 0. Two keys.
specification PassedLoopDecidesNothing {
  domain d { class Ctl { start() ok() stop() } class Dev { busy: bool  one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Choose {
      user -> ctl.start()
      alternative {
        while [dev.busy] { user -> ctl.ok() }
        urgent ctl -> dev.one()
      } or {
        urgent ctl -> dev.two()
      }
    }
  }
}
