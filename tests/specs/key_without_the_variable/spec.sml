// Copies that differ in a variable that the message does not read have one key: meeting it once meets it for all of them.
//
// Copies with floor 0 and 1, one key for both. 0: to 1 or 2. 1 and 2 turn 5: stop to 0, or a yield to 3 and 4. 5 {0, 1} turn 5:
// stop moves both, to 0, or a yield to 6. 3, 4, 6 yielded: start to 1, 2 or 5. Staying there for ever loses, except in the
// classic reading.
specification KeyWithoutTheVariable {
  domain d { class Ctl { start(floor: 0..=1) at(floor: 0..=1) } class Dev { stop() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Go {
      var 0..=1 floor
      user -> ctl.start(bind floor)
      eventually ctl -> dev.stop()
    } constraints [ ignore user -> ctl.start(*) ]
  }
}
