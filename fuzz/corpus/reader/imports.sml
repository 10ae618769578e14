import "a.sml" import "b.sml"; // c
specification X { domain { abstract class A : B { } } }