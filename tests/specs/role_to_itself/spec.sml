// A dynamic role that sends to itself is one object: of four pairs only two are events.
//
// 0: a ping of left to 1, of right to 2. 1: left again to 3, right to 4; each starts a copy too. 2 alike, to 5 and 6. 3 to 6
// turn 3: one, which as another message ends the copy that waits with the same first object: to 0, 2, 1, 0.
specification RoleToItself {
  domain d { class Ctl { start() } class Dev { one() ping() } class User { } }
  object ctl: Ctl
  object left: Dev
  object right: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    dynamic role Dev dev
    dynamic role Dev other
    guarantee scenario Echo {
      dev -> dev.ping()
      other -> other.ping()
      urgent ctl -> dev.one()
    }
  }
}
