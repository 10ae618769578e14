// A key holds the values of the variables that its message reads: two calls are two obligations of one message.
//
// Copies with floor 0 and 1, each with its key. 0: to 1 or 2. 1 turn 5: go(0) to 0, or a yield to 3; 2 alike with 4. 5 {0, 1}
// turn 5: go(0) to 2, go(1) to 1, or a yield to 6. 3, 4, 6 yielded: start to 1, 2 or 5. Staying there for ever loses, except in
// the classic reading.
specification KeyOfAVariable {
  domain d { class Ctl { start(floor: 0..=1) at(floor: 0..=1) } class Dev { go(floor: 0..=1) } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Go {
      var 0..=1 floor
      user -> ctl.start(bind floor)
      eventually ctl -> dev.go(floor)
    } constraints [ ignore user -> ctl.start(*) ]
  }
}
