// Declared initial values, those of a class and that of an object, decide what is shown.
//
// 0 nobody asks: the clock may tick. 1 `first` is to be shown; 2 `second` is. Then 0 again: three states, three
// transitions, and the environment moves in one of them. With other initial values `violation` would lose the game.
specification InitialValues {
  domain d {
    enum Mode { off, on }
    class Ctl { tick() }
    class Dev { level: 0..=4 = 3  mode: Mode = on  lit: bool  show(level: 0..=4) }
    class Clock { }
  }
  object ctl: Ctl
  object first: Dev
  object second: Dev { level: 4 }
  object clock: Clock
  controllable { Ctl }
  collaboration C {
    guarantee scenario Shows {
      clock -> ctl.tick()
      violation [first.level != 3 || second.level != 4 || first.mode == off || first.lit]
      urgent ctl -> first.show(first.level)
      urgent ctl -> second.show(second.level)
    }
  }
}
