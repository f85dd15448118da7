import sys
c,m=int(sys.argv[1]),int(sys.argv[2])
h="[derivation]\ntitle='A'\nconcerns='B'\n[symbols]\n't'={role='time'}\n'q'={role='state'}\n"
tr="".join("[[trajectory]]\nid='t%d'\nformula={'q'='t+%d'}\nspan=[0,1]\n"%(i,i) for i in range(m))
cl="".join("[[claim]]\nid='c%d'\nsays='c'\nalways=['q>t-%d']\n"%(i,i+1) for i in range(c))
open('many.toml','w').write(h+tr+cl)
