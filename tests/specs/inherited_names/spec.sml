// Effects, roles and non-spontaneous events of a class hold for its subclasses; the effect of the subclass comes in textual
// order.
//
// 0: start to 1. 1 turn 3, lift is ready: one to 2. 2 lift is busy: done to 3, by both effects neither busy nor ready; no start
// while it runs. 3: start to 4. 4: setReady would have to be caused by an assumption, so start again, to 4, is all that can
// happen. Door never moves.
specification InheritedNames {
  domain d {
    class Ctl { start()  done() }
    abstract class Dev { busy: bool  ready: bool  one() }
    class Lift : Dev { }
    class Door : Dev { }
    class User { }
  }
  object ctl: Ctl
  object lift: Lift { ready: true }
  object door: Door
  object user: User
  effects {
    Dev -> Ctl.done() { sender.busy = false }
    Ctl -> Dev.one() { receiver.busy = true }
    Lift -> Ctl.done() { sender.ready = false }
  }
  controllable { Ctl }
  non-spontaneous events { Ctl.done  Dev.setReady }
  collaboration C {
    dynamic role Dev dev
    guarantee scenario Serve bindings [ dev = lift ] {
      user -> ctl.start()
      alternative [dev.ready] { urgent ctl -> dev.one() } or { user -> door.setReady(true) }
    }
    assumption scenario Done {
      ctl -> dev.one()
      strict eventually dev -> ctl.done()
    } constraints [ forbidden user -> ctl.start() ]
  }
}
