// A variable of a loop body has no value when the loop comes round: each round binds it anew.
//
// 0: start(0) to 1, start(1) to 2. 1 turn 3: go(0) to 0. 2 turn 3: go(1) to 0. Would the loop remember, go would lead to states
// of their own.
specification LoopForgets {
  domain d { class Ctl { start(floor: 0..=1) at(floor: 0..=1) } class Dev { go(floor: 0..=1) } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Rounds {
      while {
        var 0..=1 floor
        user -> ctl.start(bind floor)
        urgent ctl -> dev.go(floor)
      }
    }
  }
}
