// What the environment has committed goes before what is urgent for the system, and this before what is urgent for the
// environment.
//
// 0: start to 1, ok and stop to 0. 1 turn 2: ok, which is committed, to 2. 2 turn 3: one to 3. 3 turn 4: stop to 0.
specification EnvironmentCommitsFirst {
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
    assumption scenario Confirm {
      user -> ctl.start()
      parallel { committed user -> ctl.ok() } and { urgent user -> ctl.stop() }
    }
  }
}
