// A binding that gives `null` leaves no copy.
//
// 0 nobody is there: start to 0, arrived to 1. 1 dev is there: start to 2; a second arrived breaks the assumption. 2 turn 3: serve to 0.
specification NullBinding {
  domain d { class Ctl { current: Dev  start() arrived() } class Dev { serve() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects {
    Dev -> Ctl.arrived() { receiver.current = sender }
    Ctl -> Dev.serve() { sender.current = null }
  }
  controllable { Ctl }
  collaboration C {
    dynamic role Dev guest
    guarantee scenario ServesWhoIsThere bindings [ guest = ctl.current ] {
      user -> ctl.start()
      urgent ctl -> guest.serve()
    }
    assumption scenario OneGuest {
      dev -> ctl.arrived()
      ctl -> dev.serve()
    } constraints [ forbidden dev -> ctl.arrived() ]
  }
}
