// A message that one scenario asks for eventually and another urgently cannot be put off: there is no yield.
//
// Copies S and N. 0: start to 1, ok to 0. 1 {S, N} turn 5, N waits for ok: one to 0, as another message of N ends it; or a
// yield to 2. 2 yielded: start to 1, ok to 3. 3 turn 3: one to 0, and no yield. Waiting for ever in 2 loses, by default.
specification UrgentHidesEventually {
  domain d { class Ctl { start() ok() stop() } class Dev { one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Sometime {
      user -> ctl.start()
      eventually ctl -> dev.one()
    }
    guarantee scenario Now {
      user -> ctl.start()
      user -> ctl.ok()
      urgent ctl -> dev.one()
    }
  }
}
