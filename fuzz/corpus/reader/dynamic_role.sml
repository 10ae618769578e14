// One scenario, a copy and a key for each device that calls.
//
// Open calls are {}, {1}, {2} or {1, 2}; all but {} twice, not yielded (turn 5) and yielded. {}: two calls. {1} and {2}: serve,
// yield. {1, 2}: two serves, yield. Each yielded one: two calls, of which one may only replace a copy by an equal one. Yielded
// ones are lost by silence; with classic semantics there is none.
specification DynamicRole {
  domain d { class Ctl { call() } class Dev { serve() } }
  object ctl: Ctl
  object dev1: Dev
  object dev2: Dev
  controllable { Ctl }
  collaboration C {
    dynamic role Dev caller
    guarantee scenario Served { caller -> ctl.call()  eventually ctl -> caller.serve() }
  }
}
