// A message in a loop of an assumption is met and open again in one step, which keeps the play fair to it: the clock ticks for
// ever.
//
// 0: ok to 1, start to 2. 1 turn 3, to set busy, to 3. 2 waits for busy: ok to 4, start ignored, to 2. 3 busy: ok to 5, start
// to 6, as it waits for nothing. 4 turn 3: to 6. 5 turn 3: to 3. 6 turn 3: one to 0. Silence in 2 is not fair to the clock,
// whose key is open in all.
specification DischargedAndOpenAgain {
  domain d { class Ctl { start() ok() stop() } class Dev { busy: bool  one() two() } class User { } }
  object ctl: Ctl
  object dev: Dev
  object user: User
  effects { Ctl -> Dev.one() { receiver.busy = false } }
  controllable { Ctl }
  collaboration C {
    assumption scenario Ticks { while { eventually user -> ctl.ok() } }
    guarantee scenario Sometime {
      while { user -> ctl.start()  wait eventually [dev.busy]  urgent ctl -> dev.one() }
    } constraints [ ignore user -> ctl.start() ]
    guarantee scenario Counts { user -> ctl.ok()  urgent ctl -> dev.setBusy(true) }
  }
}
