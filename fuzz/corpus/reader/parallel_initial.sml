// A scenario that begins with a `parallel` begins with any of its branches, and so again while a copy is active.
//
// 0: left to 1, right to 2. 1 one copy waits for right: left ends it and starts the same again, to 1; right moves it on to `go`
// and starts a copy that waits for left, to 3. 2 one copy waits for left: right to 2, left to 4, likewise. 3 and 4 turn 3: go
// ends both copies, one at its end, the other because go is a message of its scenario, to 0.
specification ParallelInitial {
  domain d { class Ctl { left() right() } class Dev { go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario TwoHands {
      parallel { user -> ctl.left() } and { user -> ctl.right() }
      urgent ctl -> dev.go()
    }
  }
}
