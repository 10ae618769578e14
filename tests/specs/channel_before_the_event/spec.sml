// A channel is asked for its link before the event: the event that cuts it still goes through, nothing after it does.
//
// 0: ok to 0, start, which cuts the link, to 1. 1 turn 3: one to 2. 2 idle: ok has no channel any more, nor has start. One is
// met once only: the other never becomes open.
specification ChannelBeforeTheEvent {
  domain d { class Ctl { start() ok() } class Dev { one() } class User { near: Ctl } }
  object ctl: Ctl
  object dev: Dev
  object user: User { near: ctl }
  effects { User -> Ctl.start() { sender.near = null } }
  controllable { Ctl }
  channels { Ctl.start over User.near  Ctl.ok over User.near }
  collaboration C {
    guarantee scenario Serve {
      user -> ctl.start()
      urgent ctl -> dev.one()
      user -> ctl.ok()
      urgent ctl -> dev.one()
    }
  }
}
