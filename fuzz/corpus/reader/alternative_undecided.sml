// An `alternative` is undecided until a message of a case happens; the obligations of all offered cases are open.
//
// 0: start to 1. 1 turn 3, before two cases, the third is not offered: one to 2, two to 0. 2: two to 0. Three keys: two stands twice.
specification AlternativeUndecided {
  domain d { class Ctl { start() } class Dev { one() two() three() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Choose {
      user -> ctl.start()
      alternative { urgent ctl -> dev.one()  urgent ctl -> dev.two() }
      or { urgent ctl -> dev.two() }
      or [1 > 2] { urgent ctl -> dev.three() }
    }
  }
}
