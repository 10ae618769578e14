// `*` matches any value, and leaves the system a choice.
//
// 0: ask(0) and ask(1) to 1. 1 turn 3: show(0) and show(1) to 0.
specification Wildcard {
  domain d { class Ctl { ask(level: 0..=1) } class Dev { show(level: 0..=1) } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Anything {
      user -> ctl.ask(*)
      urgent ctl -> dev.show(*)
    }
  }
}
