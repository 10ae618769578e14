// An obligation that is interrupted for ever is gone, not met, and the play is fair to it all the same.
//
// 0: start to 1, stop to 0. 1 waits for what never holds: start to 1; stop ends it, to 0, and the assumption says that it
// comes.
specification GoneIsFair {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Serve {
      user -> ctl.start()
      wait eventually [false]
      urgent ctl -> dev.one()
    } constraints [ interrupt user -> ctl.stop() ]
    assumption scenario Stops { while { user -> ctl.start()  eventually user -> ctl.stop() } } constraints [ ignore user -> ctl.start()  ignore user -> ctl.stop() ]
  }
}
