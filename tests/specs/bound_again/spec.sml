// `bind` to a variable that has a value matches any argument and sets it anew.
//
// 0: at to 0, start(0) to 1, start(1) to 2. 1 and 2 hold 0 and 1: at(0) to 3, at(1) to 4, whatever they hold; start to 1 or 2.
// 3 turn 3: go(0) to 0. 4 turn 3: go(1) to 0.
specification BoundAgain {
  domain d { class Ctl { start(floor: 0..=1) at(floor: 0..=1) } class Dev { go(floor: 0..=1) } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Last {
      var 0..=1 floor
      user -> ctl.start(bind floor)
      user -> ctl.at(bind floor)
      urgent ctl -> dev.go(floor)
    }
  }
}
