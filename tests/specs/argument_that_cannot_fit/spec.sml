// An argument of a wider class than its parameter matches only what fits: after the lift no event can be the second message.
//
// Copies D with dev=door and L with dev=lift. 0: door starts to 1, lift to 2, seen to 0. 1 {D}: door to 1, lift to 3, seen to
// 4. 2 {L}: door to 3, lift to 2; seen(door) is no message of L, to 2. 3 {D, L}: seen to 5. 4 turn 3: one to 0. 5 turn 3: one
// to 2.
specification ArgumentThatCannotFit {
  domain d { class Ctl { start()  seen(door: Door) } class Dev { one() } class Door : Dev { } class User { } }
  object ctl: Ctl
  object lift: Dev
  object door: Door
  object user: User
  controllable { Ctl }
  collaboration C {
    dynamic role Dev dev
    guarantee scenario Seen {
      dev -> ctl.start()
      user -> ctl.seen(dev)
      urgent ctl -> dev.one()
    }
  }
}
