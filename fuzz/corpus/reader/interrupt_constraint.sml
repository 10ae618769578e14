// An `interrupt` constraint ends a copy without harm.
//
// 0 nothing: start to 1, stop to 0. 1 `go` is open, turn 5: go to 0, yield to 2. 2 the same, yielded: start ends the copy,
// since it is one of the scenario's own messages, and starts a new one, to 1; stop interrupts, to 0. Silence in 2 is
// lost by default; with classic semantics there is none, and the system wins from 2 as well.
specification InterruptConstraint {
  domain d { class Ctl { start() stop() } class Dev { go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Run {
      user -> ctl.start()
      eventually ctl -> dev.go()
    } constraints [ interrupt user -> ctl.stop() ]
  }
}
