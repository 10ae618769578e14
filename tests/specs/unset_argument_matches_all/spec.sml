// A constraint over a variable without a value forbids every argument; once the variable is bound, only that one.
//
// 0: start to 1, at to 0. 1 floor has no value: either start loses, at(0) to 2, at(1) to 3. 2 floor is 0: start(0) loses;
// start(1) hits the initial message, ends the copy and starts another, to 1; at(1) ends it, and so does at(0), another message,
// both to 0. 3 alike for 1.
specification UnsetArgumentMatchesAll {
  domain d { class Ctl { start(floor: 0..=1) at(floor: 0..=1) } class Dev { go(floor: 0..=1) } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario NoOther {
      var 0..=1 floor
      user -> ctl.start(*)
      user -> ctl.at(bind floor)
      user -> ctl.at(1)
    } constraints [ forbidden user -> ctl.start(floor) ]
  }
}
