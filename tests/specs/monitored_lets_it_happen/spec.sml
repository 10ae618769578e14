// A monitored message of an assumption lets a non-spontaneous event happen and forces no turn; a message without modality does
// not let it.
//
// 0: start to 1. 1 turn 6, as monitored: ok to 2, or start to 1; `Stops` lets no stop happen. 2 turn 3: one to 3. 3: start to
// 1, `Stops` ignores it and a second copy would be equal. 0 has only start, which alone is spontaneous, and `Stops` still
// stands in 3: not the same.
specification MonitoredLetsItHappen {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  non-spontaneous events { Ctl.ok  Ctl.stop }
  collaboration C {
    guarantee scenario Serve {
      user -> ctl.ok()
      urgent ctl -> dev.one()
    }
    assumption scenario Confirms {
      user -> ctl.start()
      monitored urgent user -> ctl.ok()
    }
    assumption scenario Stops {
      user -> ctl.start()
      user -> ctl.stop()
    } constraints [ ignore user -> ctl.start() ]
  }
}
