// A scenario that starts at once evaluates its bindings in the initial state; one that gives `null` never starts.
//
// 0 turn 5: one of left to 1, or a yield to 2. 1 and 2: start to 0, from 1 by moving on, from 2 ignored. Waiting in 2 for ever
// loses, except in the classic reading. The scenario bound to `null` would never let the environment have a turn.
specification StartsWithABinding {
  domain d { class Ctl { start() met(dev: Dev) } class Dev { peer: Dev  one() } class User { } }
  object ctl: Ctl
  object left: Dev
  object right: Dev { peer: left }
  object user: User
  controllable { Ctl }
  collaboration C {
    dynamic role Dev dev
    guarantee scenario Blinks bindings [ dev = right.peer ] {
      while { eventually ctl -> dev.one()  user -> ctl.start() }
    } constraints [ ignore user -> ctl.start() ]
    guarantee scenario Never bindings [ dev = left.peer ] {
      while { urgent ctl -> dev.one() }
    }
  }
}
