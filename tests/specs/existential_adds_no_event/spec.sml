// A message that stands in an existential scenario only is no event of the environment.
//
// 0: start to 1. 1 turn 3: one to 0. Of ok there is no edge.
specification ExistentialAddsNoEvent {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Serve {
      user -> ctl.start()
      urgent ctl -> dev.one()
    }
    existential scenario Example {
      user -> ctl.start()
      ctl -> dev.one()
      user -> ctl.ok()
    }
  }
}
