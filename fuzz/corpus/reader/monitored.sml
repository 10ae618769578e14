// A monitored message is an obligation that the scenario does not cause; here another one does, when it is polled.
//
// Copies of `Monitors` (M), `Goes` (G), and one of `Polls` always. 0 {}: start to 1, poll to 2. 1 {M}: start to 1, poll to 3.
// 2 {G} turn 5: go to 0, yield to 4. 3 {M, G} turn 5: go to 0, yield to 5. 4 {G} yielded: start to 3, poll to 2. 5 {M, G}
// yielded: start and poll to 3.
specification Monitored {
  domain d { class Ctl { start() poll() } class Dev { go() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  controllable { Ctl }
  collaboration C {
    guarantee scenario Monitors { user -> ctl.start()  monitored eventually ctl -> dev.go() }
    guarantee scenario Goes { user -> ctl.poll()  eventually ctl -> dev.go() }
    assumption scenario Polls { while { eventually user -> ctl.poll() } }
  }
}
