// A scenario that begins with a `wait` is active from the start, once.
//
// 0 off: turned to 1. 1 on, turn 3: off to 2. 2 off, the scenario is over: turned to 3. 3 on: turned to 3.
specification StartsAtOnce {
  domain d { class Ctl { turned() } class Dev { on: bool  off() } }
  object ctl: Ctl
  object dev: Dev
  effects {
    Dev -> Ctl.turned() { sender.on = true }
    Ctl -> Dev.off() { receiver.on = false }
  }
  controllable { Ctl }
  collaboration C {
    guarantee scenario OffOnce { wait [dev.on]  urgent ctl -> dev.off() }
    assumption scenario Turned { dev -> ctl.turned() }
  }
}
