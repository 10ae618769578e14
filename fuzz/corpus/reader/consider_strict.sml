// A strict cut makes a violation of what would only end the copy, for its own messages and for those it considers.
//
// 0 nothing: start to 1, stop to 0. 1 turn 5: go to 0, yield to 2. 2 yielded: start and stop both violate `Quickly`, to
// the lost state. The system wins from 0 and 1 by not yielding.
specification ConsiderStrict {
  domain d { class Ctl { start() stop() } class Dev { go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Goes { user -> ctl.start()  eventually ctl -> dev.go() }
    guarantee scenario Quickly {
      user -> ctl.start()
      strict ctl -> dev.go()
    } constraints [ consider user -> ctl.stop() ]
  }
}
