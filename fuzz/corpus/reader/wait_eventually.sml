// `wait eventually` is an obligation that is met by what the environment promises.
//
// 0 off: start to 1, turned to 2. 1 waits: start ends the copy and starts another, to 1; turned passes the wait and ends it, to 2.
// 2 on: start starts a copy that is over at once, and turned changes nothing, both to 2. Silence in 1 is unfair to `TurnsOn`,
// whose `turned` is always open and discharged by each.
specification WaitEventually {
  domain d { class Ctl { start() turned() } class Dev { on: bool } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects { Dev -> Ctl.turned() { sender.on = true } }
  controllable { Ctl }
  collaboration C {
    guarantee scenario GetsOn { user -> ctl.start()  wait eventually [dev.on] }
    assumption scenario TurnsOn { while { eventually dev -> ctl.turned() } }
  }
}
