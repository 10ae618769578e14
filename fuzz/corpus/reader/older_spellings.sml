system specification Old {
  domain d { enum E { a, b } class L { n: 0..=3 = 1 e: E = b go(x: 0..=3, y: E) } class C { c: L tell() } class U { } }
  object c: C { c: l }
  object l: L { n: 2, e: E:a }
  object u: U
  effects { C -> L.go(x, y) { receiver.n = x; receiver.e = y } }
  controllable { C }
  non-spontaneous events { C.tell }
  parameter ranges { L.go(x = [0..2, 3] y = [a]) }
  channels { L.go over C.c }
  collaboration K {
    static role C c
    dynamic role L some
    /// requirement
    specification scenario S with dynamic bindings [ bind some to c.c ] {
      message u -> c.tell()
      var 0..=3 v = 0
      wait until [v < 3 && (some.n != 1 || some.e == a) => true]
      message strict eventually c -> some.go(*, bind to w)
      interrupt if [-v + 1 * 2 == 3] violation if [some == null]
    } constraints [ ignore message c -> some.go(bind v, b) ]
    assumption scenario A { l -> c.tell() monitored committed u -> c.tell }
    existential scenario X { while [c.c.n > 0] { parallel { c -> l.go(1, a) } and { { wait strict eventually [l.n == 1] } } } }
  }
}
