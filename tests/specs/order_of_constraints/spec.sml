// One message under all four constraints: `ignore` counts before `forbidden`, `forbidden` before `interrupt`, `interrupt`
// before `consider`.
//
// Copies I of `Ignored`, A of `Interrupted`, F of `Forbidden`. 0: ok to 0, start to 1, stop to 2. 1 {I, A}: ok ends A, to 3;
// stop ends both and starts F, to 2; start would violate A, which is strict there. 2 {F}: ok loses; start to 5; stop ends F and
// starts it, to 2. 3 {I}: ok to 3; stop to 2; start violates I, which is strict: lost. 5 {I, A, F}: ok loses, stop to 2. With
// the lost state six.
specification OrderOfConstraints {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Ignored {
      user -> ctl.start()
      { strict user -> ctl.stop() } constraints [ consider user -> ctl.ok()  forbidden user -> ctl.ok()  ignore user -> ctl.ok() ]
    }
    assumption scenario Interrupted {
      user -> ctl.start()
      { strict user -> ctl.stop() } constraints [ consider user -> ctl.ok()  interrupt user -> ctl.ok() ]
    }
    guarantee scenario Forbidden {
      user -> ctl.stop()
      { user -> ctl.stop() } constraints [ interrupt user -> ctl.ok()  forbidden user -> ctl.ok() ]
    }
  }
}
