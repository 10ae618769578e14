// A binding that gives `null` leaves no copy.
//
// 0 nobody is there: s }
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
