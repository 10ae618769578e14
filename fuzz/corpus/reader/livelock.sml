// An obligation that is open again whenever it is met, and nothing else ever happens: if the system keeps meeting it, no super step ends.
//
// 0 turn 5: blink to 0, yield to 1. 1 yielded, idle. Staying in 0 is unfair to super steps, silence in 1 to blink.
specification Livelock {
  domain d { class Ctl { } class Dev { blink() } }
  object ctl: Ctl
  object dev: Dev
  controllable { Ctl }
  collaboration C {
    guarantee scenario Blinks { while { eventually ctl -> dev.blink() } }
  }
}
