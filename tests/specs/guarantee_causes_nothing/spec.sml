// A message with a modality in a guarantee does not make a non-spontaneous event of the environment possible: it can only be
// hoped for.
//
// 0: start to 1. 1: start to 1, another copy for the one that it ends. Ok never happens, so the obligation is never met: not
// realizable.
specification GuaranteeCausesNothing {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  non-spontaneous events { Ctl.ok  Ctl.stop }
  collaboration C {
    guarantee scenario Hopes {
      user -> ctl.start()
      eventually user -> ctl.ok()
    }
  }
}
