// The environment can violate a guarantee outright: a second start before the stop.
//
// 0 nothing: start to 1, stop to 0. 1 turn 3: go to 2. 2 waits for stop: stop to 0, start to the lost state.
specification ForbiddenConstraint {
  domain d { class Ctl { start() stop() } class Dev { go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Once {
      user -> ctl.start()
      urgent ctl -> dev.go()
      user -> ctl.stop()
    } constraints [ forbidden user -> ctl.start() ]
  }
}
