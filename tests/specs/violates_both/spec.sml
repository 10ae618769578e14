// An event of the environment that violates a guarantee and an assumption cannot happen; one that violates the guarantee only
// loses.
//
// 0: ok and stop to 0, start to 1. 1: start to 1; stop loses; ok, which would break both, cannot happen.
specification ViolatesBoth {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Never {
      user -> ctl.start()
      ctl -> dev.one()
    } constraints [ forbidden user -> ctl.ok()  forbidden user -> ctl.stop() ]
    assumption scenario NotOk {
      user -> ctl.start()
      ctl -> dev.one()
    } constraints [ forbidden user -> ctl.ok() ]
  }
}
