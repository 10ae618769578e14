// Only a device that is linked to the controller can call it.
//
// 0 dev1 is linked: it calls, to 1. 1 turn 3: serve to 2. 2 nobody is linked: idle.
specification Channels {
  domain d { class Ctl { call() } class Dev { boss: Ctl  serve() } }
  object ctl: Ctl
  object dev1: Dev { boss: ctl }
  object dev2: Dev
  effects { Ctl -> Dev.serve() { receiver.boss = null } }
  controllable { Ctl }
  channels { Ctl.call over Dev.boss }
  collaboration C {
    dynamic role Dev caller
    guarantee scenario Served { caller -> ctl.call()  urgent ctl -> caller.serve() }
  }
}
