// The system can break an assumption: it must not, or that wins the game (classic semantics).
//
// `Goes` (G) and `AcknowledgedFirst` (A). 0 {}: start to 1, ack to 0. 1 {G} turn 5: go to 2, yield to 3. 2 {A}: start to 4, ack to 0.
// 3 {G} yielded: start and ack to 1. 4 {A, G}: a second go would break A. By default it is turn 6: start to 4, ack to 1, and
// silence for ever, so the environment wins everywhere. Classic: turn 5: go to the won state, yield to 5. 5 {A, G} yielded:
// start to 4, ack to 1. There the environment is never silent, and the system wins everywhere.
specification BreaksAssumption {
  domain d { class Ctl { start() ack() } class Dev { go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Goes { user -> ctl.start()  eventually ctl -> dev.go() }
    assumption scenario AcknowledgedFirst {
      ctl -> dev.go()
      user -> ctl.ack()
    } constraints [ forbidden ctl -> dev.go() ]
  }
}
