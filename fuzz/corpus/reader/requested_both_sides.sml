// Turns 3 and 4 in this order.
//
// 0: start to 1, confirm to 0. 1 turn 3: go to 2. 2 turn 4: confirm to 0; start is no choice there, and neither is silence.
specification RequestedBothSides {
  domain d { class Ctl { start() confirm() } class Dev { go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    assumption scenario Confirms { user -> ctl.start()  urgent user -> ctl.confirm() }
    guarantee scenario Goes { user -> ctl.start()  requested ctl -> dev.go() }
  }
}
