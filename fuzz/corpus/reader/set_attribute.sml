// An implicit operation sets an attribute, whoever sends it.
//
// 0 level = 0: setLevel(2) by the user to 1. 1 level = 2, turn 3: setLevel(0) by the controller to 0.
specification SetAttribute {
  domain d { class Ctl { } class Dev { level: 0..=2 } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario BackToZero { user -> dev.setLevel(2)  urgent ctl -> dev.setLevel(0) }
  }
}
