// A system event that would violate an assumption cannot happen by default; the classic reading lets it, and it wins there.
//
// 0: ok to 0, start to 1. 1 turn 3: two to 2, one breaks the assumption. 2 turn 6, one is blocked: ok to 3, start to 1. 3 turn
// 3: one to 0. The environment may withhold ok: lost. Classic: in 1 one is won, two to 2; 2 turn 3: one is won. With the won
// state four.
specification ClashWonInClassic {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Asks { user -> ctl.start()  urgent ctl -> dev.one() }
    guarantee scenario Rather { user -> ctl.start()  urgent ctl -> dev.two() }
    assumption scenario NoOne { user -> ctl.start()  user -> ctl.ok() } constraints [ forbidden ctl -> dev.one()  ignore user -> ctl.start() ]
  }
}
