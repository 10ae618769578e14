// `interrupt [c]` ends a copy without harm in some states of the world.
//
// 0 off: start to 1, turned to 2. 1 turn 3: go to 0. 2 on: start is interrupted at once, and turned changes nothing, both to 2.
specification InterruptCondition {
  domain d { class Ctl { start() turned() } class Dev { on: bool  go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects { Dev -> Ctl.turned() { sender.on = true } }
  controllable { Ctl }
  collaboration C {
    guarantee scenario GoUnlessOn {
      user -> ctl.start()
      interrupt [dev.on]
      urgent ctl -> dev.go()
    }
    assumption scenario Turned { dev -> ctl.turned() }
  }
}
