// Of two cases that could move without a message the textually first is decided; the other is not offered any more.
//
// The second case passes its `wait` first, so one and two are never asked for: no key but that of super steps. 0: start to 1,
// ok to 0. 1 waits for ok: ok to 0; start ends the copy and starts another, to 1.
specification SilentCaseFirst {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Choose {
      user -> ctl.start()
      alternative { urgent ctl -> dev.one() }
      or { wait [true]  user -> ctl.ok() }
      or { wait [true]  urgent ctl -> dev.two() }
    }
  }
}
