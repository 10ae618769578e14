// A loop over an integer attribute.
//
// 0 n = 0: start to 1. 1 n = 0: tick to 2. 2 n = 1: tick to 3. 3 n = 2, behind the loop: done to 0.
specification WhileLoop {
  domain d { class Ctl { start() } class Dev { n: 0..=2  tick() done() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects {
    Ctl -> Dev.tick() { receiver.n = receiver.n + 1 }
    Ctl -> Dev.done() { receiver.n = 0 }
  }
  controllable { Ctl }
  collaboration C {
    guarantee scenario Twice {
      user -> ctl.start()
      while [dev.n < 2] { urgent ctl -> dev.tick() }
      urgent ctl -> dev.done()
    }
  }
}
