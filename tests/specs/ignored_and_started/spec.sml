// `ignore` keeps the copy but starts another one all the same; copies that have become equal are one.
//
// Copies behind start: a with 1, of start(0), b with 0, of start(1); and c with 0 behind at. 0 {}, 1 {a}, 2 {b}, 3 {c}, 4 {a,
// b}, 5 {a, c}, 6 {b, c}, 7 all. Start adds a or b and keeps the others. At makes a and b the one c, any argument; a c that it
// finds ends, at(0) by passing, at(1) as another message. Four events everywhere.
specification IgnoredAndStarted {
  domain d { class Ctl { start(floor: 0..=1) at(floor: 0..=1) } class Dev { go(floor: 0..=1) } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Go {
      var 0..=1 floor
      user -> ctl.start(bind floor)
      floor = 1 - floor * floor
      user -> ctl.at(*)
      floor = 0
      user -> ctl.at(floor)
    } constraints [ ignore user -> ctl.start(*) ]
  }
}
