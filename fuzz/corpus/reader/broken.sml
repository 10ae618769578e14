specification Tür { object 'a': 0x1f # €
 /* /* */ wait [a = b]