// Ranges bound what the environment says, not what the system computes; a constant outside is never said.
//
// 0: ask(1), ask(2), ask(5) to 1, 2, 3; ask(7) is outside the range. 1, 2, 3 turn 3: show of the same value to 0, though 5 alone
// is in the range of show.
specification Ranges {
  domain d { class Ctl { ask(level: 0..=9) } class Dev { show(level: 0..=9) go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  parameter ranges { Ctl.ask(level = [1..2, 5])  Dev.show(level = [5]) }
  collaboration C {
    guarantee scenario Echo {
      var 0..=9 level
      user -> ctl.ask(bind level)
      urgent ctl -> dev.show(level)
    }
    guarantee scenario Never { user -> ctl.ask(7)  urgent ctl -> dev.go() }
  }
}
