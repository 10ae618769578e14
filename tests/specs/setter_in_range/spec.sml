// A range limits what the environment sets and what `*` stands for; the value that the system computes may lie outside.
//
// The environment sets 0, 1, 2 in every state of its own: to 0, 1, 2. 1 turn 3: 0, 1 or 2, as `*` has that range too, to 0, 3,
// 4. 2 turn 3: sets 3, outside, to 5. 3, 4, 5 have those levels and no copy. `Never` never starts, as no environment sets 3.
specification SetterInRange {
  domain d { class Ctl { start() } class Dev { level: 0..=3  one() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  parameter ranges { Dev.setLevel(level = [0, 1..=2]) }
  collaboration C {
    guarantee scenario Refill {
      user -> dev.setLevel(*)
      alternative [dev.level == 2] { urgent ctl -> dev.setLevel(dev.level + 1) }
      or [dev.level == 1] { urgent ctl -> dev.setLevel(*) }
    }
    guarantee scenario Never {
      user -> dev.setLevel(3)
      violation [true]
    }
  }
}
