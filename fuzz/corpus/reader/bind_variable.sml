// A bound variable is part of the state, and of the key of the obligation that reads it.
//
// 0: ask(0) to 1, ask(1) to 2. 1 turn 3: show(0) to 0. 2 turn 3: show(1) to 0. The same message has a key for each value.
specification BindVariable {
  domain d { class Ctl { ask(level: 0..=1) } class Dev { show(level: 0..=1) } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Echo {
      var 0..=1 level
      user -> ctl.ask(bind level)
      urgent ctl -> dev.show(level)
    }
  }
}
