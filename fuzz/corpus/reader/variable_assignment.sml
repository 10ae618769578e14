// A variable counts the rounds of a loop; it is forgotten where its body ends.
//
// 0: start to 1. 1 count = 0, turn 3: tick to 2. 2 count = 1, turn 3: tick to 0, since the loop ends with count = 2 and the copy with
// it. The message reads no variable, so there is one key.
specification VariableAssignment {
  domain d { class Ctl { start() } class Dev { tick() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Twice {
      user -> ctl.start()
      var 0..=2 count = 0
      while [count < 2] {
        urgent ctl -> dev.tick()
        count = count + 1
      }
    }
  }
}
